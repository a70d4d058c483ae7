// Files that come in and go out. Nothing is sent anywhere.
import { batch } from '@preact/signals';
import { EngineError } from '../engine/module';
import { Scene, parseScene, sceneToml } from '../engine/scene';
import { makeGas, opened, saveGas, said } from '../gas/model';
import { announce, engine, load, sceneOf, setup, disksNow } from '../lab/model';
import { setupOf } from '../lab/presets';
import { strings } from '../strings';
import { tab } from '../ui/app';

/** More disks than this are a gas. */
const mostInLab = 20;
/** Of a file: a hundred thousand disks take half of that. */
const mostBytes = 20e6;
/** Of what is wrong with a file so much is said. */
const mostProblems = 3;

export function save(name: string, content: string | Blob): void {
  const blob = typeof content === 'string' ? new Blob([content], { type: 'text/plain;charset=utf-8' }) : content;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function refuse(name: string, reason: string): void {
  const problems = reason.split('\n');
  const more = problems.length - mostProblems;
  const shown = problems.slice(0, mostProblems).join('\n');
  const message = `${name}: ${shown}${more > 0 ? `\n${strings.value.shareMenu.more(more)}` : ''}`;
  announce(message);
  said.value = message;
}

export async function openSceneText(text: string, name: string): Promise<void> {
  const words = strings.value;
  let scene: Scene;
  try {
    // An engine of its own: a file that is made to break one breaks no other.
    scene = parseScene(await engine().another(), text);
  } catch (error) {
    refuse(name, error instanceof EngineError ? error.message : words.shareMenu.notRead);
    return;
  }
  if (scene.disks.length > mostInLab && !(scene.width > 0 && scene.height > 0)) {
    announce(words.shareMenu.noBox);
    return;
  }
  if (scene.disks.length > mostInLab) {
    batch(() => {
      opened.value = text;
      tab.value = 'gas';
    });
    makeGas();
    said.value = words.shareMenu.tooMany(scene.disks.length);
    return;
  }
  load(setupOf(scene));
  tab.value = 'lab';
  announce(words.shareMenu.opened(name));
}

export async function openFile(file: File): Promise<void> {
  if (file.size > mostBytes) refuse(file.name, strings.value.shareMenu.tooLarge);
  else await openSceneText(await file.text(), file.name);
}

export function saveScene(): void {
  if (tab.value === 'gas') saveGas((toml) => save('gas.toml', toml));
  else save('disks.toml', sceneToml({ ...sceneOf(setup.value), disks: disksNow.value }));
}

/** For useEffect: takes dropped scene files until the function returned is called. */
export function acceptDroppedFiles(): () => void {
  const over = (event: DragEvent): void => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
  };
  const drop = (event: DragEvent): void => {
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    void openFile(file);
  };
  document.addEventListener('dragover', over);
  document.addEventListener('drop', drop);
  return () => {
    document.removeEventListener('dragover', over);
    document.removeEventListener('drop', drop);
  };
}

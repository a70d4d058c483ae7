// The dialog "Share and save".
import { useRef } from 'preact/hooks';
import type { Contact } from '../engine/playback';
import { announce, contactsSoFar, playback } from '../lab/model';
import { history as measurements, recorded, said, saveRecorded } from '../gas/model';
import { gasDrawing } from '../gas/stage';
import { strings } from '../strings';
import { tab } from '../ui/app';
import { Dialog, dialog } from '../ui/dialog';
import { addressNow } from './address';
import { copyText } from './clipboard';
import { openFile, save, saveScene } from './files';
import { pngOfCanvas, pngOfSvg, standaloneSvg } from './picture';
import { csvOf, csvOfGas } from './table';

export function ShareDialog() {
  const words = strings.value;
  const menu = words.shareMenu;
  const picker = useRef<HTMLInputElement>(null);
  const inLab = tab.value === 'lab';
  const someRecorded = recorded.value !== null;
  return (
    <Dialog name="share" heading={menu.heading}>
      <div class="menu">
        <button type="button" id="copy-link" onClick={() => void copyLink()}>
          {menu.link}
        </button>
        <button type="button" id="open-scene" onClick={() => picker.current!.click()}>
          {menu.openScene}
        </button>
        <input
          ref={picker}
          id="scene-file"
          type="file"
          accept=".toml,.txt"
          hidden
          onChange={(event) => {
            const file = event.currentTarget.files?.[0];
            if (file) void openFile(file);
            event.currentTarget.value = '';
            dialog.value = null;
          }}
        />
        <button type="button" id="save-scene" onClick={saveScene}>
          {menu.saveScene}
        </button>
        <button type="button" id="save-png" onClick={() => void savePng()}>
          {menu.png}
        </button>
        <button type="button" id="save-svg" onClick={saveSvg}>
          {menu.svg}
        </button>
        <button type="button" id="save-csv" onClick={saveCsv}>
          {inLab ? menu.csv : menu.csvOfGas}
        </button>
        {!inLab && (
          <button type="button" id="save-collisions" aria-disabled={!someRecorded} onClick={saveCollisions} aria-describedby={someRecorded ? undefined : 'none-recorded'}>
            {menu.csvOfCollisions}
          </button>
        )}
      </div>
      {!inLab && !someRecorded && (
        <p class="note" id="none-recorded">
          {menu.noneRecorded}
        </p>
      )}
      <p class="note">{menu.drop}</p>
    </Dialog>
  );
}

async function copyLink(): Promise<void> {
  const address = addressNow();
  history.replaceState(null, '', address);
  const words = (await copyText(address)) ? strings.value.copied : strings.value.notCopied;
  announce(words);
  said.value = words;
  dialog.value = null;
}

async function savePng(): Promise<void> {
  const gas = gasDrawing.value;
  save(gas ? 'gas.png' : 'collision.png', await (gas ? pngOfCanvas(gas.copy()) : pngOfSvg(standaloneSvg())));
}

function saveSvg(): void {
  const gas = gasDrawing.value;
  save(gas ? 'gas.svg' : 'collision.svg', gas ? gas.svg() : standaloneSvg());
}

function saveCollisions(): void {
  if (recorded.value) saveRecorded((csv) => save('collisions.csv', csv));
}

function saveCsv(): void {
  if (tab.value === 'gas') return save('gas.csv', csvOfGas(measurements.value));
  const contacts: Contact[] = [];
  for (let k = 0; k < contactsSoFar.value; ++k) contacts.push(playback.value.contact(k)!);
  save('contacts.csv', csvOf(contacts));
}

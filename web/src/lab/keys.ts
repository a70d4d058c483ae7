// Keys that move things, and keys that work everywhere on the tab.
import type { Vec } from '../engine/playback';
import { nextContact, playing, previousContact, restart, slow, step } from './model';

/** Which way an arrow key or WASD points; nothing for other keys. */
export function arrowKey(event: KeyboardEvent): Vec | undefined {
  if (event.ctrlKey || event.altKey || event.metaKey) return undefined;
  switch (event.key.toLowerCase()) {
    case 'arrowleft':
    case 'a':
      return { x: -1, y: 0 };
    case 'arrowright':
    case 'd':
      return { x: 1, y: 0 };
    case 'arrowup':
    case 'w':
      return { x: 0, y: 1 };
    case 'arrowdown':
    case 's':
      return { x: 0, y: -1 };
    default:
      return undefined;
  }
}

/** Whether the key belongs to the control that has the focus. */
function isTyping(target: EventTarget | null): boolean {
  return target instanceof Element && target.matches('input[type=text], select, textarea, dialog *');
}

/** Shortcuts of the tab "Two disks". Returns true if the key was one. */
export function labShortcut(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.altKey || event.metaKey || isTyping(event.target)) return false;
  switch (event.key.toLowerCase()) {
    case ' ':
      if (event.target instanceof Element && event.target.matches('button, summary, a, input')) return false;
      playing.value = !playing.value;
      return true;
    case 'n':
      nextContact();
      return true;
    case 'b':
      previousContact();
      return true;
    case '.':
      step(1);
      return true;
    case ',':
      step(-1);
      return true;
    case 'r':
      restart();
      return true;
    case 'l':
      slow.value = !slow.value;
      return true;
    default:
      return false;
  }
}

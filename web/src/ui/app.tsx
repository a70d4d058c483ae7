// The page's frame: tabs, language, theme, dialogs.
import { signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { GasTab } from '../gas/tab';
import { Lab } from '../lab/lab';
import { playing } from '../lab/model';
import { acceptDroppedFiles } from '../share/files';
import { ShareDialog } from '../share/dialog';
import { Language, language, languages, strings } from '../strings';
import { Dialog, dialog } from './dialog';
import { dark } from './theme';

export type Tab = 'lab' | 'gas';
export const tab = signal<Tab>('lab');

export function App() {
  const words = strings.value;
  useEffect(() => {
    document.documentElement.lang = language.value;
    document.title = words.title;
  }, [language.value]);
  useEffect(acceptDroppedFiles, []);
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => {
      const typing = event.target instanceof Element && event.target.matches('input[type=text]');
      if (event.key === '?' && !typing) dialog.value = 'keys';
    };
    document.addEventListener('keydown', onKey);
    return () => document.removeEventListener('keydown', onKey);
  }, []);
  return (
    <>
      <a class="skip" href="#main">
        {words.skip}
      </a>
      <Header />
      {tab.value === 'lab' ? <Lab /> : <GasTab />}
      <Dialog name="keys" heading={words.keys.heading}>
        <dl class="keys">
          {words.keys.list.map(([keys, what]) => (
            <div key={keys}>
              <dt>
                <kbd>{keys}</kbd>
              </dt>
              <dd>{what}</dd>
            </div>
          ))}
        </dl>
      </Dialog>
      <ShareDialog />
    </>
  );
}

function Header() {
  const words = strings.value;
  const open = (next: Tab): void => {
    playing.value = false;
    tab.value = next;
  };
  return (
    <header class="top">
      <span class="brand">{words.title}</span>
      <nav class="tabs">
        {(['lab', 'gas'] as const).map((name) => (
          <button key={name} type="button" id={`tab-${name}`} aria-current={tab.value === name ? 'page' : undefined} onClick={() => open(name)}>
            {words.tabs[name]}
          </button>
        ))}
      </nav>
      <div class="tools">
        <button type="button" id="open-share" onClick={() => (dialog.value = 'share')}>
          {words.share}
        </button>
        <button type="button" id="open-keys" onClick={() => (dialog.value = 'keys')}>
          {words.help}
        </button>
        <button type="button" id="theme" aria-pressed={dark.value} onClick={() => (dark.value = !dark.value)}>
          {words.theme}
        </button>
        <label>
          <span class="hidden">{words.language}</span>
          <select id="language" value={language.value} onChange={(event) => (language.value = event.currentTarget.value as Language)}>
            {Object.entries(languages).map(([code, { name }]) => (
              <option key={code} value={code} lang={code}>
                {name}
              </option>
            ))}
          </select>
        </label>
      </div>
    </header>
  );
}

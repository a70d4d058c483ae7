import { render } from 'preact';
import 'katex/dist/katex.min.css';
import './style/index.css';
import { loadModule } from '#load';
import { Engine } from './engine/module';
import { startLab } from './lab/model';
import { strings } from './strings';
import { App } from './ui/app';
import { startTheme } from './ui/theme';
import { startGas } from './gas/model';
import { openAddress } from './share/address';

async function start(): Promise<void> {
  startTheme();
  const place = document.getElementById('app')!;
  try {
    const module = await loadModule();
    startLab(await Engine.start(module));
    startGas(module);
    openAddress();
    place.textContent = '';
    render(<App />, place);
    document.documentElement.dataset.ready = 'yes';
  } catch (error) {
    place.textContent = strings.value.failed + (error instanceof Error ? error.message : String(error));
    throw error;
  }
}

void start();

// The worker as a file beside the page.
import GasWorker from './worker?worker';

export const startWorker = (): Worker => new GasWorker();

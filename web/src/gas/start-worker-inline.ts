// The worker from within the page of one file.
import GasWorker from './worker?worker&inline';

export const startWorker = (): Worker => new GasWorker();

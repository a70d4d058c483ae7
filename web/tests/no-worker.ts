// In Node the gas has no worker.
export const startWorker = (): Worker => {
  throw new Error('there is no worker here');
};

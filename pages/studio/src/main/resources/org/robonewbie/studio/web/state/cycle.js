/** Simulated duration of one cycle. */
export const CYCLE_SECONDS = 0.02;

/** How long the simulator simulates in one cycle. */
export const CYCLE_SECONDS = 0.02;

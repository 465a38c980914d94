/** Trials that people watch at the pace of their clock: {@link org.robonewbie.trial.watch.WatchedTrial}. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.watch;

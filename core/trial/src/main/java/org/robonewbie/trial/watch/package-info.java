/**
 * Real-time views of trials: {@link org.robonewbie.trial.watch.WatchedTrial}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.watch;

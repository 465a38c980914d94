/**
 * Recordings and their summaries for the replay. Start with {@link org.robonewbie.studio.replay.ReplayService}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.replay;

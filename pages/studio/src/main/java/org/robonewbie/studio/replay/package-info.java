/**
 * The server's side of the replay: recordings for the pages. Read {@link org.robonewbie.studio.replay.ReplayApi} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.replay;

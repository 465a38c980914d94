/** The server's side of the replay: recordings for the pages. Read {@link org.robonewbie.studio.replay.ReplayApi} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.replay;

/** Tests of the replay's files. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.replay;

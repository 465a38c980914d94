/** Tests of what the motion editor asks of the studio. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.motion;

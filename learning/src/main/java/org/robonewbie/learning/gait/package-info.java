/**
 * Steps as keyframes: where the feet shall go becomes angles of the legs. Read {@link org.robonewbie.learning.gait.Footsteps}
 * first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.gait;

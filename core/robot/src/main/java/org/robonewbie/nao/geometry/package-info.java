/** Points, angles and poses on the ground. Read {@link org.robonewbie.nao.geometry.Pose2d} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.geometry;

/** Tests of kinematics. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.kinematics;

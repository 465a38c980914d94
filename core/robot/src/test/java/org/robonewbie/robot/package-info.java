/** Tests of the robots as data. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.robot;

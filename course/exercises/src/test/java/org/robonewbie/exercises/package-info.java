/** Tests of the exercises and of what grades them. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises;

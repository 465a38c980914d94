/** Reference solutions, which no student gets with the program. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.solution;

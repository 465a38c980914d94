/** Tests of marking a class. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.marking;

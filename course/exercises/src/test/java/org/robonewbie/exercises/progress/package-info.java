/** Tests of progress and of help that opens step by step. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.progress;

/** The wire of SimSpark: what agents and simulator say to each other. Start in {@code perceptor} and {@code effector}. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol;

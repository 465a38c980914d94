/**
 * Tasks for learning programs in other languages, and the server through which they are reached. Read {@link
 * org.robonewbie.learning.gym.GymTask} first, then {@link org.robonewbie.learning.gym.GymServer}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.gym;

/**
 * A walk into any direction, calculated anew in each cycle: for those who want to see how walking works. Read {@link
 * org.robonewbie.agent.walk.Walk} first, then {@link org.robonewbie.agent.walk.WalkEngine}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.walk;

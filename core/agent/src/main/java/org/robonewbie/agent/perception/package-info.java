/**
 * What the robot makes of its perceptors: what it remembers of the field, and whether it stands. Read {@link
 * org.robonewbie.agent.perception.LocalFieldView} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.perception;

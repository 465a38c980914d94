/**
 * Processed perception: the memory of the field, and the detection of falls. Read {@link
 * org.robonewbie.agent.perception.LocalFieldView} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.perception;

/**
 * Trainer commands that change the simulated world or control its clock, and their format in SimSpark's trainer protocol. Read {@link
 * org.robonewbie.protocol.order.Order} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.order;

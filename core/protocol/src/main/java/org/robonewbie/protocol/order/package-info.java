/**
 * Orders to the world from outside, and their form in SimSpark's trainer protocol. Read {@link org.robonewbie.protocol.order.Order} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.order;

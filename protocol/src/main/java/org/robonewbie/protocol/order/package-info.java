/** Orders to the world from outside, and their form in SimSpark's trainer protocol. Read {@link org.robonewbie.protocol.order.Order} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.order;

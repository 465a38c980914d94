/** Tests of orders and of the trainer protocol. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.order;

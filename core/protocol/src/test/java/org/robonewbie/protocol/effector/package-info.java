/** Tests of effector messages. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.effector;

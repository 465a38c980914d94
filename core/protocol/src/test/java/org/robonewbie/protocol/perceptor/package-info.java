/** Tests of perceptor messages. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.perceptor;

/** Tests of the wire. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol;

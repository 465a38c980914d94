/** Tests of the S-expression reader and writer. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.telemetry;

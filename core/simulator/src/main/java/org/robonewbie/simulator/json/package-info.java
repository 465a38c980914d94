/** Construction of JSON. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.json;

/**
 * Work on several threads, where there are some.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.threads;

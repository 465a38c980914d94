/**
 * The command line. The entry point is {@link org.robonewbie.app.Main}; its commands are in {@code command}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app;

/**
 * Stands in for {@code org.slf4j}, which looks for loggers by means that a page does not have.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.web.library.org.slf4j;

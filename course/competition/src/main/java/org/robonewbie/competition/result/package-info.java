/**
 * Results of a contest on disk: finished trials, the table as HTML, CSV and JSON, and certificates. Read {@link
 * org.robonewbie.competition.result.ResultFolder} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.result;

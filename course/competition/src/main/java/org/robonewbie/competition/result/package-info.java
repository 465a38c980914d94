/**
 * What is kept of a contest: finished trials, the table as page, CSV and JSON, certificates. Start reading with {@link org.robonewbie.competition.result.ResultFolder}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.result;

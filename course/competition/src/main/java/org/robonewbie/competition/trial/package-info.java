/**
 * Execution of one trial with the programs of its teams: a challenge for one robot ({@link
 * org.robonewbie.competition.trial.ChallengePlayer}), or a game of two teams with a simulator and a supervisor ({@link
 * org.robonewbie.competition.trial.TrialRunner}).
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.trial;

package org.robonewbie.learning.policy;

import org.robonewbie.agent.policy.Policy;

/** A world in which lessons are given, one after the other. */
public interface Classroom extends AutoCloseable {

    /**
     * Gives a lesson.
     *
     * @param seed chooses what happens in it; learners with equal seeds get the same lesson
     * @param numbers what the learner knows
     * @return what came of it
     */
    LessonFigures give(long seed, double... numbers);

    /**
     * Gives a lesson of an exam.
     *
     * @param seed chooses what happens in it
     * @param policy what the learner knows
     * @return what came of it
     * @throws IllegalArgumentException if the policy was learned for something else
     */
    LessonFigures examine(long seed, Policy policy);

    @Override
    void close();
}

package org.robonewbie.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.service.CourseHost.State;
import org.robonewbie.pagejvm.JavaSource;
import org.robonewbie.studio.PageFeed;

class ExerciseAttemptTest {

    private static final double TURN_SECONDS = 0.02;

    private final List<String> told = new ArrayList<>();
    private final List<Grade> complete = new ArrayList<>();
    private int frames;

    private final PageFeed.Page page = new PageFeed.Page() {

        @Override
        public void send(String json) {
            told.add(json);
        }

        @Override
        public void show(byte[] frame) {
            frames++;
        }

        @Override
        public void keep(String note) {}
    };

    @Test
    void trialsAreShownAndJudgedOneAfterTheOther() {
        Exercise first = Exercises.all().get(0);
        ExerciseAttempt attempt = attempt(first, Solutions.text(first));

        Grade end = played(attempt);

        assertThat(end.trials()).hasSize(2);
        assertThat(end.passed()).isTrue();
        assertThat(complete).containsExactly(end);
        assertThat(frames).isPositive();
        assertThat(told).anyMatch(news -> news.contains("\"task\":\"raise-arms\"") && news.contains("\"seed\":2"));
    }

    @Test
    void programThatNeverReturnsIsTriedOnce() {
        ExerciseAttempt attempt = attempt(
                Exercises.all().get(0),
                "public class RaiseArms extends org.robonewbie.agent.Agent {\nprotected void think() {\nwhile (true) {\n}\n}\n}");

        Grade end = played(attempt);

        assertThat(end.toString())
                .contains("think() has not returned; it is in RaiseArms.java:3.")
                .contains("Skipped because an earlier trial did not finish.");
    }

    private ExerciseAttempt attempt(Exercise exercise, String text) {
        Map<String, byte[]> classes = JavaSource.compile(exercise.className(), text);
        ExerciseAttempt attempt =
                new ExerciseAttempt(exercise, List.copyOf(classes.values()), 1, 2, page, complete::add);
        attempt.world().ask("{\"do\":\"speed\",\"factor\":\"fastest\"}");
        return attempt;
    }

    private Grade played(ExerciseAttempt attempt) {
        while (attempt.status().state() != State.OVER) {
            attempt.turn(TURN_SECONDS);
            attempt.world().ask("{\"do\":\"seen\"}");
        }
        return attempt.status().grade();
    }
}

package org.robonewbie.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;
import org.robonewbie.studio.PageFeed;
import org.robonewbie.pagejvm.JavaSource;

class ExerciseAttemptTest {

    private static final double TURN_SECONDS = 0.02;

    private final List<String> told = new ArrayList<>();
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

        JsonObject end = played(attempt);

        assertThat(end.getAsJsonArray("judged"))
                .hasSize(2)
                .allSatisfy(trial -> assertThat(
                                trial.getAsJsonObject().get("passed").getAsBoolean())
                        .isTrue());
        assertThat(frames).isPositive();
        assertThat(told).anyMatch(news -> news.contains("\"task\":\"raise-arms\"") && news.contains("\"seed\":2"));
    }

    @Test
    void programThatNeverReturnsIsTriedOnce() {
        ExerciseAttempt attempt = attempt(
                Exercises.all().get(0),
                "public class RaiseArms extends org.robonewbie.agent.Agent {\nprotected void think() {\nwhile (true) {\n}\n}\n}");

        JsonObject end = played(attempt);

        assertThat(end.getAsJsonArray("judged").toString())
                .contains("think() has not returned; it is in RaiseArms.java:3.")
                .contains("Not tried");
    }

    private ExerciseAttempt attempt(Exercise exercise, String text) {
        Map<String, byte[]> classes = JavaSource.compile(exercise.className(), text);
        ExerciseAttempt attempt = new ExerciseAttempt(exercise, List.copyOf(classes.values()), 1, 2, page);
        attempt.world().ask("{\"do\":\"speed\",\"factor\":\"fastest\"}");
        return attempt;
    }

    private JsonObject played(ExerciseAttempt attempt) {
        JsonObject state = state(attempt);
        while (!state.get("state").getAsString().equals("OVER")) {
            attempt.turn(TURN_SECONDS);
            attempt.world().ask("{\"do\":\"seen\"}");
            state = state(attempt);
        }
        return state;
    }

    private static JsonObject state(ExerciseAttempt attempt) {
        return JsonParser.parseString(attempt.json(Language.ENGLISH)).getAsJsonObject();
    }
}

package org.robonewbie.exercises.service;

import com.google.gson.JsonObject;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.FirstMinute;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.progress.Progress;
import org.robonewbie.simulator.json.Json;

/** Writes the levels of the {@link FirstMinute}, with the accompanying text for the page. */
record FirstMinuteWriter(Language language, Progress progress) {

    JsonObject json() {
        return Json.object(
                "levels", Json.array(FirstMinute.levels().stream().map(this::level)),
                "words", words());
    }

    private JsonObject level(Exercise level) {
        return Json.object(
                "name", level.name(),
                "title", language.translated(level.title()),
                "goal", language.translated(level.goal()),
                "file", level.fileName(),
                "passed", progress.of(level).passed(),
                "start", level.startCode(),
                "solution", FirstMinute.solution(level));
    }

    private JsonObject words() {
        return Json.object(
                "level", language.translated("Level"),
                "edit", language.translated("Type it, or press Tab:"),
                "run", language.translated("Press ▶ Run (Ctrl+Enter)."),
                "watch", language.translated("Watch the robot …"),
                "passed", language.translated("Well done:"),
                "failed", language.translated("Not yet:"),
                "broken", language.translated("Fix the line marked in red first."),
                "next", language.translated("Next level"),
                "finish", language.translated("Go on with exercise 1"),
                "skip", language.translated("Skip"),
                "skipHint", language.translated("Hides these three levels permanently"));
    }
}

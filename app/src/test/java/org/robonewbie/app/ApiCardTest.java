package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Robot;
import org.robonewbie.agent.log.Logger;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.Joint;

/** The card on one page says nothing that does not exist. */
class ApiCardTest {

    private static final Pattern CALL =
            Pattern.compile("\\b(nao|motions|walk|fieldView|lookAround|item|log)\\.([a-z]\\w*)\\(");
    private static final Map<String, Class<?>> TYPES = Map.of(
            "nao", Robot.class,
            "motions", Motions.class,
            "walk", Walk.class,
            "fieldView", LocalFieldView.class,
            "lookAround", LookAround.class,
            "item", FieldItem.class,
            "log", Logger.class);
    private static final List<String> ONLY_ON_NAO = List.of("sense", "act", "perform");

    private final String card = Project.read(Project.ROOT.resolve("docs/teaching/api-card.html"));

    @Test
    void eachMethodOfTheCardExists() {
        assertThat(CALL.matcher(card).results().filter(call -> !ONLY_ON_NAO.contains(call.group(2))))
                .hasSizeGreaterThan(40)
                .allMatch(call -> Arrays.stream(
                                TYPES.getOrDefault(call.group(1), Void.class).getMethods())
                        .anyMatch(method -> method.getName().equals(call.group(2))));
    }

    @Test
    void allJointsAndPositionsAreNamed() {
        assertThat(Joint.values()).allMatch(joint -> card.contains(joint.name().replaceFirst("^(LEFT|RIGHT)_", "")));
        assertThat(BodyPosition.values()).allMatch(position -> card.contains(position.name()));
    }
}

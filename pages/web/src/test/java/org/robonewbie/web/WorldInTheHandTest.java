package org.robonewbie.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.examples.Agent_SimpleSoccer;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.pagejvm.JavaSource;
import org.robonewbie.pagejvm.Program;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.studio.PageFeed;

/** Changes of the page's world by the user: undo, and robots steered by hand. */
class WorldInTheHandTest {

    private static final double SECONDS = 0.02;

    private final List<JsonObject> told = new ArrayList<>();
    private final List<FreePitch> pitches = new ArrayList<>();
    private final PacedWorld world = new PacedWorld(
            new PageFeed.Page() {

                @Override
                public void send(String json) {
                    told.add(JsonParser.parseString(json).getAsJsonObject());
                }

                @Override
                public void show(byte[] frame) {
                    // polled by now()
                }

                @Override
                public void keep(String note) {
                    // discarded
                }
            },
            feed -> {
                pitches.add(new FreePitch(1, feed, new PageRecording()).with(new Agent_BetterSoccer()));
                return pitches.get(0);
            });

    @Test
    void walkingRobotIsRestoredAndContinues() {
        cycle(200);
        world.ask("{\"do\":\"pause\"}");
        Pose before = robot(1).body().torso();
        world.ask("{\"do\":\"placeRobot\",\"side\":\"left\",\"number\":1,\"x\":-3,\"y\":2,\"z\":0.4,"
                + "\"headingDegrees\":90}");
        step(5);
        assertThat(robot(1).body().position().y()).isBetween(1.8, 2.2);

        world.ask("{\"do\":\"undo\"}");

        assertThat(robot(1).body().torso()).isEqualTo(before);
        assertThat(world.now().paused()).isTrue();
        world.ask("{\"do\":\"resume\"}");
        cycle(200);
        assertThat(robot(1).body().isStanding()).isTrue();
        assertThat(sentences()).containsExactly("Undone: robot moved.");
    }

    @Test
    void robotThatHasJoinedSinceKeepsItsPosition() {
        FreePitch pitch = pitches.get(0);
        world.ask("{\"do\":\"placeBall\",\"x\":2,\"y\":1,\"z\":0.042}");
        pitch.with(new Agent_SimpleSoccer());

        world.ask("{\"do\":\"undo\"}");
        cycle(1);

        assertThat(world.now().ballPosition().x()).isBetween(-0.1, 0.1);
        assertThat(world.now().robots()).hasSize(2);
        assertThat(sentences())
                .containsExactly(
                        "Undone: ball moved. The world was restored only approximately: speeds are estimated.");
    }

    @ParameterizedTest
    @ValueSource(strings = {"""
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;
            public class Raising extends Agent {
                protected void think() {
                    nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 60, 90);
                }
            }
            """, """
            import org.robonewbie.agent.Nao;
            import org.robonewbie.nao.Joint;
            public class Raising {
                public static void main(String[] args) {
                    Nao nao = Nao.connect(args);
                    nao.perform("wave");
                    while (nao.sense()) {
                        nao.setJointAngle(Joint.LEFT_SHOULDER_PITCH, 60, 90);
                        nao.act();
                    }
                }
            }
            """})
    void studentsProgramSurvivesAJumpOfTheWorld(String text) {
        StudentRun run = new StudentRun();
        pitches.get(0).with(new Program(JavaSource.compile("Raising", text).values()), run);
        cycle(20);
        world.ask("{\"do\":\"pause\"}");
        List<Pose> before = torsos();
        world.ask("{\"do\":\"placeRobot\",\"side\":\"left\",\"number\":2,\"x\":-3,\"y\":2,\"z\":0.4,"
                + "\"headingDegrees\":90}");
        step(3);

        world.ask("{\"do\":\"undo\"}");

        assertThat(torsos()).isEqualTo(before);
        world.ask("{\"do\":\"resume\"}");
        cycle(600);
        assertThat(run.text()).isEqualTo("RUNNING\t0\t");
        assertThat(robot(2).body().degrees(Joint.LEFT_SHOULDER_PITCH)).isBetween(59.0, 61.0);
        assertThat(sentences()).containsExactly("Undone: robot moved.");
    }

    @Test
    void jointOfAPuppetGoesWhereTheSliderIs() {
        cycle(10);
        world.ask("{\"do\":\"addPuppet\",\"side\":\"left\"}");
        world.ask("{\"do\":\"hold\",\"side\":\"left\",\"number\":2,\"joint\":\"LEFT_SHOULDER_PITCH\",\"degrees\":80}");

        cycle(200);

        assertThat(robot(2).body().degrees(Joint.LEFT_SHOULDER_PITCH)).isBetween(78.0, 82.0);
        assertThat(robot(2).team()).isEqualTo("RoboNewbie");
    }

    @Test
    void puppetStandsBehindTheBallAndTheOtherRobotAndWalks() {
        world.ask("{\"do\":\"pause\"}");
        world.ask("{\"do\":\"addPuppet\",\"side\":\"left\"}");
        step(30);
        double start = robot(2).body().position().x();
        assertThat(start).isCloseTo(-0.9, within(0.05));

        world.ask("{\"do\":\"walk\",\"side\":\"left\",\"number\":2,\"forward\":-1,\"left\":0,\"turn\":0}");
        step(150);

        assertThat(robot(2).body().position().x()).isLessThan(start - 0.3);
        assertThat(robot(2).body().isStanding()).isTrue();
    }

    @Test
    void removedPuppetReturnsToItsPosition() {
        world.ask("{\"do\":\"addPuppet\",\"side\":\"left\"}");
        cycle(50);
        world.ask("{\"do\":\"pause\"}");
        Pose place = robot(2).body().torso();

        world.ask("{\"do\":\"removePuppet\",\"side\":\"left\",\"number\":2}");
        assertThat(world.now().robots()).hasSize(1);
        world.ask("{\"do\":\"undo\"}");

        assertThat(robot(2).body().torso()).isEqualTo(place);
        world.ask("{\"do\":\"redo\"}");
        assertThat(world.now().robots()).hasSize(1);
        world.ask("{\"do\":\"undo\"}");
        world.ask("{\"do\":\"undo\"}");
        assertThat(world.now().robots()).hasSize(1);
        cycle(1);
        assertThat(sentences())
                .containsExactly(
                        "Undone: puppet removed.",
                        "Redone: puppet removed.",
                        "Undone: puppet removed.",
                        "Undone: puppet added.");
    }

    private void step(int cycles) {
        for (int i = 0; i < cycles; i++) {
            world.ask("{\"do\":\"step\",\"cycles\":1}");
            cycle(1);
        }
    }

    private void cycle(int cycles) {
        for (int i = 0; i < cycles; i++) {
            world.turn(SECONDS);
            world.ask("{\"do\":\"seen\"}");
        }
    }

    private RobotSnapshot robot(int number) {
        return world.now().robots().stream()
                .filter(robot -> robot.number() == number)
                .findFirst()
                .orElseThrow();
    }

    private List<Pose> torsos() {
        return world.now().robots().stream().map(robot -> robot.body().torso()).toList();
    }

    private List<String> sentences() {
        return told.stream()
                .filter(news -> news.get("kind").getAsString().equals("told"))
                .map(news -> news.get("text").getAsString())
                .filter(text -> text.contains("one"))
                .toList();
    }
}

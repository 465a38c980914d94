package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorCommand.Synchronise;
import student.Careless;

class AgentTest {

    private final PrintStream usual = System.err;
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();

    @BeforeEach
    void listen() {
        System.setErr(new PrintStream(printed, true, StandardCharsets.UTF_8));
    }

    @AfterEach
    void stopListening() {
        System.setErr(usual);
    }

    @Test
    void answersEachMessageWithItsCommandsAndOneSynchronisation() {
        AgentDriver agent = new AgentDriver(new Careless(nao -> {
            nao.setJointSpeed(Joint.NECK_YAW, 90);
            nao.say("hello");
        }));

        List<EffectorCommand> answer = agent.respond(Messages.standing().build());

        assertThat(answer).hasSize(3);
        assertThat(((SetHingeSpeed) answer.get(0)).effectorName()).isEqualTo("he1");
        assertThat(((SetHingeSpeed) answer.get(0)).radiansPerSecond()).isCloseTo(Math.PI / 2, within(1e-8));
        assertThat(answer.get(1)).isEqualTo(new Say("hello"));
        assertThat(answer.get(2)).isEqualTo(new Synchronise());
    }

    @Test
    void stopsAMotorOnceAndThenSaysNoMoreAboutIt() {
        AtomicInteger cycle = new AtomicInteger();
        AgentDriver agent = new AgentDriver(new Careless(nao -> {
            if (cycle.incrementAndGet() <= 2) {
                nao.setJointSpeed(Joint.NECK_YAW, cycle.get() == 1 ? 50 : 0);
            }
        }));

        agent.respond(Messages.standing().at(1.00).build());
        List<EffectorCommand> second =
                agent.respond(Messages.standing().at(1.02).build());
        List<EffectorCommand> third = agent.respond(Messages.standing().at(1.04).build());

        assertThat(second).containsExactly(new SetHingeSpeed("he1", 0), new Synchronise());
        assertThat(third).containsExactly(new Synchronise());
    }

    @Test
    void reportsSpeedNaNOnceWithTimeAndLine() {
        AgentDriver agent = new AgentDriver(new Careless(Careless::speedNaN));

        agent.respond(Messages.standing().at(1.00).build());
        List<EffectorCommand> answer =
                agent.respond(Messages.standing().at(1.02).build());

        assertThat(answer).containsExactly(new Synchronise());
        assertThat(printedLines())
                .containsExactly(
                        "1.00 s: Joint speed NaN for LEFT_KNEE_PITCH is ignored. Was something divided by zero?"
                                + " (Careless.java:31)");
    }

    @Test
    void reportsAnAngleBeyondTheRangeAndGoesToItsEnd() {
        AgentDriver agent = new AgentDriver(new Careless(Careless::beyondRange));
        Posture nearlyThere = Posture.ZERO.with(Joint.LEFT_KNEE_PITCH, 0.8);

        agent.respond(Messages.standing().posture(nearlyThere).build());
        List<EffectorCommand> answer =
                agent.respond(Messages.standing().at(2).posture(nearlyThere).build());

        assertThat(printedLines())
                .containsExactly(
                        "1.00 s: Joint angle 200.0 for LEFT_KNEE_PITCH is beyond its range of -130 to 1 degrees;"
                                + " it is limited to the range. (Careless.java:36)");
        assertThat(answer).containsExactly(new SetHingeSpeed("lle4", 0), new Synchronise());
    }

    @Test
    void asksForASpeedAboveZeroInsteadOfADirection() {
        AgentDriver agent = new AgentDriver(new Careless(nao -> nao.setJointAngle(Joint.LEFT_KNEE_PITCH, -10, -20)));

        agent.respond(Messages.standing().build());

        assertThat(printedLines())
                .singleElement()
                .asString()
                .contains("Joint angle -10.0 with speed -20.0 for LEFT_KNEE_PITCH is ignored. Use a speed above 0;"
                        + " the target angle determines the direction.");
    }

    @Test
    void stopsAJointAtTheEndOfItsRange() {
        AgentDriver agent = new AgentDriver(new Careless(nao -> nao.setJointSpeed(Joint.NECK_PITCH, 100)));
        Posture atTheEnd = Posture.ZERO.with(Joint.NECK_PITCH, 44.9);

        List<EffectorCommand> answer =
                agent.respond(Messages.standing().posture(atTheEnd).build());

        assertThat(answer).containsExactly(new Synchronise());
        assertThat(printedLines()).hasSize(1);
        assertThat(printedLines().get(0))
                .startsWith("1.00 s: NECK_PITCH has reached the end of its range (-45 to 45 degrees) at 44.9 and stops"
                        + " there; set another speed. (");
    }

    @Test
    void clampsASpeedThatNoMotorCanReach() {
        AgentDriver agent = new AgentDriver(new Careless(nao -> nao.setJointSpeed(Joint.NECK_YAW, 1000)));

        List<EffectorCommand> answer = agent.respond(Messages.standing().build());

        assertThat(((SetHingeSpeed) answer.get(0)).radiansPerSecond()).isCloseTo(Math.toRadians(351.77), within(1e-8));
        assertThat(printedLines().get(0))
                .startsWith("1.00 s: Joint speed 1000 for NECK_YAW exceeds its maximum; it is limited to 351.77"
                        + " degrees per second.");
    }

    @Test
    void goesOnAfterAnExceptionAndNamesItsLine() {
        AgentDriver agent = new AgentDriver(new Careless(Careless::exception));

        List<EffectorCommand> first = agent.respond(Messages.standing().build());
        List<EffectorCommand> second = agent.respond(Messages.standing().build());

        assertThat(first).containsExactly(new Synchronise());
        assertThat(second).containsExactly(new Synchronise());
        assertThat(printedLines())
                .containsExactly("1.00 s: think() failed with java.lang.ArrayIndexOutOfBoundsException: Index 22 out of"
                        + " bounds for length 22; the robot continues with the next step. Called from Careless.java:25."
                        + " (Careless.java:42)");
    }

    @Test
    void saysOnceWhatIsWrongWithAPatternOfTheLog() {
        AgentDriver agent = new AgentDriver(Careless.withWrongPattern());

        agent.respond(Messages.standing().build());
        agent.respond(Messages.standing().build());

        assertThat(printedLines())
                .singleElement()
                .asString()
                .matches(
                        "1\\.00 s: %d is for whole numbers; use %\\.1f for 0\\.0, in \"angle %d\"\\. \\(Careless\\.java:\\d+\\)");
    }

    @Test
    void endsARunWithoutMemoryInOneSentence() {
        AgentDriver agent = new AgentDriver(new Careless(Careless::tooMuch));

        assertThatThrownBy(() -> agent.respond(Messages.standing().build())).isInstanceOf(OutOfMemoryError.class);

        assertThat(agent.hasFailed()).isTrue();
        assertThat(printedLines())
                .singleElement()
                .asString()
                .matches("1\\.00 s: think\\(\\) ran out of memory; the run ends here\\. Does a list or map"
                        + " grow in every cycle\\? \\(Careless\\.java:\\d+\\)");
    }

    @Test
    void namesTheLineOfAFieldThatCouldNotBePreparedAndOnlyThat() {
        AgentDriver agent = new AgentDriver(new Careless(Careless::brokenTable));

        agent.respond(Messages.standing().build());
        agent.respond(Messages.standing().build());

        assertThat(printedLines())
                .singleElement()
                .asString()
                .matches(
                        "1\\.00 s: think\\(\\) failed with java\\.lang\\.NumberFormatException: For input string: \"fast\";"
                                + " the robot continues with the next step\\. Called from [^()]+\\. \\(Careless\\.java:\\d+\\)");
    }

    @Test
    void saysOnceThatAMotionAndACommandWantTheSameJoint() {
        AgentDriver agent = new AgentDriver(new Agent() {
            @Override
            protected void think() {
                motions.start("wave");
                Careless.motionAndCommand(nao);
            }
        });

        for (int cycle = 0; cycle < 100; cycle++) {
            agent.respond(Messages.standing().at(cycle * 0.02).build());
        }

        assertThat(printedLines())
                .singleElement()
                .asString()
                .containsPattern(
                        "RIGHT_SHOULDER_PITCH is also moved by the motion \"\\w+\": it follows this command until the next"
                                + " motion starts\\. Wait for motions\\.isFinished\\(\\), or leave the joint to the motion\\."
                                + " \\(Careless\\.java:\\d+\\)");
    }

    @Test
    void watchesForAThinkThatIsMissing() {
        AgentDriver agent = new AgentDriver(new Agent() {});

        agent.watch(slowness -> {}).close();

        assertThat(printedLines())
                .containsExactly("0.00 s: Agent has no think(); the robot does nothing. Put its behaviour in:"
                        + " protected void think() { ... }");
    }

    @Test
    void refusesATextThatIsTooLong() {
        AgentDriver agent = new AgentDriver(new Careless(Careless::longSpeech));

        List<EffectorCommand> answer = agent.respond(Messages.standing().build());

        assertThat(answer).containsExactly(new Synchronise());
        assertThat(printedLines().get(0))
                .contains("A robot can say at most 20 characters")
                .endsWith("(Careless.java:47)");
    }

    @Test
    void beamsOnlyWithTheRefereesLeaveButTellsSo() {
        AgentDriver agent = new AgentDriver(new Careless(nao -> nao.beam(-1, 0.5, 90)));

        List<EffectorCommand> allowed =
                agent.respond(Messages.standing().in(PlayMode.GOAL_LEFT).build());
        int warningsWhileAllowed = printedLines().size();
        agent.respond(Messages.standing().in(PlayMode.PLAY_ON).build());

        assertThat(allowed).containsExactly(new Beam(new Pose2d(-1, 0.5, 90)), new Synchronise());
        assertThat(warningsWhileAllowed).isZero();
        assertThat(printedLines().get(0)).contains("does not allow a beam in play mode PLAY_ON");
    }

    @Test
    void sendsTheAnswerEvenIfActIsOverriddenWrongly() {
        AgentDriver agent = new AgentDriver(new Agent() {
            @Override
            protected void act() {
                // forgets super.act()
            }
        });

        List<EffectorCommand> answer = agent.respond(Messages.standing().build());

        assertThat(answer).containsExactly(new Synchronise());
        assertThat(printedLines())
                .containsExactly("1.00 s: act() did not call super.act(); the framework did it instead.");
    }

    @Test
    void readsTheSensorsEvenIfSenseIsOverriddenWrongly() {
        List<Double> times = new ArrayList<>();
        AgentDriver agent = new AgentDriver(new Agent() {
            @Override
            protected void sense() {
                // forgets super.sense()
            }

            @Override
            protected void think() {
                times.add(nao.getTime());
            }
        });

        for (int i = 1; i <= 3; i++) {
            agent.respond(Messages.standing().at(i).build());
        }

        assertThat(times).containsExactly(0.0, 2.0, 3.0);
        assertThat(printedLines())
                .containsExactly("1.00 s: sense() did not call super.sense(); the framework did it instead.");
    }

    @Test
    void namesTheStepThatHasFailedAndAnswersAllTheSame() {
        AgentDriver agent = new AgentDriver(new Agent() {
            @Override
            protected void act() {
                nao.setJointSpeed(Joint.NECK_YAW, 90);
                throw new IllegalStateException("broken");
            }
        });

        List<EffectorCommand> answer = agent.respond(Messages.standing().build());

        assertThat(answer).containsExactly(new SetHingeSpeed("he1", Math.PI / 2), new Synchronise());
        assertThat(agent.hasFailed()).isTrue();
        assertThat(printedLines())
                .singleElement()
                .asString()
                .startsWith("1.00 s: act() failed with java.lang.IllegalStateException: broken");
    }

    @Test
    void leavesTheGameAfterTheCycleInWhichItWantsTo() {
        AgentDriver agent = new AgentDriver(new Agent() {
            @Override
            protected void think() {
                leaveGame();
            }
        });

        List<EffectorCommand> last = agent.respond(Messages.standing().at(1).build());
        List<EffectorCommand> none = agent.respond(Messages.standing().at(2).build());

        assertThat(last).containsExactly(new Synchronise());
        assertThat(none).isEmpty();
    }

    @Test
    void reachesAnAngleExactlyInSpiteOfTheDelay() {
        AgentDriver agent = new AgentDriver(new Careless(nao -> nao.setJointAngle(Joint.NECK_YAW, 30, 100)));
        double angle = 0;
        double underWay = 0;

        for (int i = 0; i < 30; i++) {
            List<EffectorCommand> answer = agent.respond(Messages.standing()
                    .posture(Posture.ZERO.with(Joint.NECK_YAW, angle))
                    .build());
            angle += underWay * 0.02;
            underWay = answer.get(0) instanceof SetHingeSpeed hinge ? Math.toDegrees(hinge.radiansPerSecond()) : 0;
        }

        assertThat(angle).isCloseTo(30, within(1e-6));
    }

    private List<String> printedLines() {
        return printed.toString(StandardCharsets.UTF_8).lines().toList();
    }
}

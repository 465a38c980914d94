package org.robonewbie.exercises.solution;

import java.util.Comparator;
import java.util.Optional;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.Kick;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.talk.Talk;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.team.world.Mate;
import org.robonewbie.team.world.WorldModel;

/** Passes to the mate to whom the way is freest, and keeps the direction of a kick. */
public final class BetterPass extends Agent {

    /** An opponent is remembered for 4 s where it was, and the robot needs a moment to know its own place again. */
    private static final double MEMORY_SECONDS = 6;

    private final WorldModel world = new WorldModel();
    private final Limbs body = new Limbs(nao, walk, motions, lookAround);
    private final Kick kick = new Kick(body, new Footwork(walk));
    private final Gaze gaze = new Gaze(body);
    private Optional<Double> direction = Optional.empty();
    private boolean passed;
    private double arrivedSeconds;

    /** Creates the solution. */
    public BetterPass() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        walk.setStyle(Footwork.STYLE);
    }

    @Override
    protected void think() {
        world.update(nao, fieldView);
        world.listen(nao);
        gaze.look(world);
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (nao.getNumber() == 1) {
            pass();
        }
        speak();
    }

    private void pass() {
        double metres = world.ballFromHere().length();
        passed = metres > 0.9 || (passed && metres > 0.6);
        if (passed || world.ballAgeSeconds() > 1) {
            direction = Optional.empty();
            arrivedSeconds = world.seconds();
            walk.stop();
            return;
        }
        boolean fresh = world.seconds() - arrivedSeconds > MEMORY_SECONDS;
        if (direction.isEmpty() && fresh && world.mates().size() == 2) {
            direction = freest().map(mate -> mate.place().minus(world.ball()).degrees());
        }
        if (direction.isPresent() && motions.isFinished()) {
            kick.kick(world, direction.get());
        }
    }

    private Optional<Mate> freest() {
        return world.mates().stream().max(Comparator.comparingDouble(this::freeMetres));
    }

    /** How near an opponent comes to the way from the ball to a mate. */
    private double freeMetres(Mate mate) {
        return world.opponents().stream()
                .mapToDouble(opponent -> opponent.distanceToSegment(world.ball(), mate.place()))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }

    private void speak() {
        if (Talk.isMyTurn(nao.getTime(), nao.getNumber())) {
            nao.say(new TeamMessage(
                            nao.getNumber(),
                            world.pose(),
                            false,
                            TeamRole.FORWARD,
                            world.ball(),
                            Translation2d.ORIGIN,
                            0,
                            9,
                            0,
                            Translation2d.ORIGIN)
                    .encode());
        }
    }
}

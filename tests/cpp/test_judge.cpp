// When the judge takes a pose that a search found, and when it says that it cannot tell.

#include "pilotage/judge.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/matchers.hpp"
#include "support/robots.hpp"

namespace pilotage::test {
namespace {

MarkerSet first_markers(int count) {
    MarkerSet markers;
    for (int i = 0; i < count; ++i) markers.add(MarkerSet::of(i));
    return markers;
}

/// A robot that moves on between frames, and what its search tells the judge of each. Places are
/// those where it began.
class Hearing {
   public:
    Judgement judgement;
    Claim claim;
    bool whole = true;

    /// An idea of where the robot is now, if it began at a pose; better than the estimate by so
    /// many nats, by all sightings and by the latest alike.
    [[nodiscard]] Hypothesis idea(const Pose<double>& began, double nats) const {
        Hypothesis h;
        h.pose = Frame(began).out_of(odometry_);
        h.covariance = Pose<double>(4e-4, 4e-4, 1e-4).asDiagonal();
        h.log_evidence = claim.log_evidence + nats;
        h.gain = nats;
        h.markers = first_markers(3);
        return h;
    }

    /// An estimate by which the robot began at the origin.
    void claims(bool confirmed) {
        claim.made = true;
        claim.confirmed = confirmed;
        claim.pose = odometry_;
        claim.covariance = Pose<double>(0.01, 0.01, 0.001).asDiagonal();
    }

    void move(double distance_m = judging::kWay_m / (judging::kFrames - 1) + 0.001,
              double turn_rad = 0.01) {
        odometry_ = after_arc(odometry_, distance_m, turn_rad);
        if (claim.made) claim.pose = odometry_;
    }

    /// \return the place in `found` of the one that wins, -1 if none does
    int ask(const std::vector<Hypothesis>& found) {
        const Hypothesis* winner = judge(
            judgement, claim, {found.data(), static_cast<int>(found.size()), whole}, odometry_);
        return winner == nullptr ? -1 : static_cast<int>(winner - found.data());
    }

    /// Asks as often as it takes, with way enough in between.
    /// \return the finding of the last but one frame
    Finding ask_to_the_end(const Pose<double>& began, double nats) {
        Finding finding = Finding::fine;
        for (int i = 1; i <= judging::kFrames; ++i) {
            finding = judgement.finding;
            const int winner = ask({idea(began, nats)});
            EXPECT_EQ(winner, i < judging::kFrames ? -1 : 0) << "frame " << i;
            EXPECT_EQ(judgement.held, i);
            move();
        }
        return finding;
    }

   private:
    Pose<double> odometry_{0, 0, 0};
};

const Pose<double> kHere(0, 0, 0), kThere(5, -2, 1), kElsewhere(-4, 3, -2);

TEST(JudgeTest, FindsNothingAmissWhereNothingWasFound) {
    Hearing hearing;
    EXPECT_EQ(hearing.ask({}), -1);
    EXPECT_EQ(hearing.judgement.finding, Finding::fine);
    for (const bool confirmed : {false, true}) {
        hearing.claims(confirmed);
        EXPECT_EQ(hearing.ask({}), -1);
        EXPECT_EQ(hearing.judgement.finding, Finding::fine);
    }
}

TEST(JudgeTest, TakesAPoseWhereThereIsNoneIfItIsFarBetterThanChance) {
    Hearing hearing;
    EXPECT_EQ(hearing.ask({hearing.idea(kThere, judging::kDecisive - 0.1)}), -1);
    EXPECT_EQ(hearing.judgement.finding, Finding::fine) << "it may be chance";
    EXPECT_EQ(hearing.judgement.held, 0);
    EXPECT_EQ(hearing.ask_to_the_end(kThere, judging::kDecisive + 0.1), Finding::elsewhere);
}

TEST(JudgeTest, DoubtsAConfirmedEstimateBeforeItGivesItUp) {
    Hearing hearing;
    hearing.claims(true);
    hearing.ask({hearing.idea(kThere, judging::kSuspicious - 0.1)});
    EXPECT_EQ(hearing.judgement.finding, Finding::fine);
    for (const double nats : {judging::kSuspicious + 0.1, judging::kDecisive - 0.1}) {
        hearing.ask({hearing.idea(kThere, nats)});
        EXPECT_EQ(hearing.judgement.finding, Finding::ambiguous);
        EXPECT_EQ(hearing.judgement.margin, nats) << "is what it says";
    }
    for (int frame = 0; frame < 20; ++frame) {
        EXPECT_EQ(hearing.ask({hearing.idea(kThere, judging::kMoved - 0.1)}), -1);
        EXPECT_EQ(hearing.judgement.finding, Finding::elsewhere) << "but not believed yet";
        hearing.move();
    }
    EXPECT_EQ(hearing.ask_to_the_end(kThere, judging::kMoved + 0.1), Finding::elsewhere);
}

/// What spoke for it before does not count: the robot may just have been carried off.
TEST(JudgeTest, HoldsAConfirmedEstimateAgainstTheLatestSightingsAlone) {
    for (const bool late : {true, false}) {
        Hearing hearing;
        hearing.claims(true);
        Hypothesis other = hearing.idea(kThere, late ? 20 : 0);
        other.log_evidence = late ? -1000 : 1000;
        hearing.ask({other});
        EXPECT_EQ(hearing.judgement.finding, late ? Finding::elsewhere : Finding::fine);
    }
}

TEST(JudgeTest, HoldsAnEstimateThatIsNotConfirmedAgainstAllSightings) {
    Hearing hearing;
    hearing.claim.log_evidence = 40;
    hearing.claims(false);
    for (const double gain : {-1000.0, 1000.0}) {
        Hypothesis rival = hearing.idea(kThere, -judging::kDecisive - 0.1);
        rival.gain = gain;
        hearing.ask({rival});
        EXPECT_EQ(hearing.judgement.finding, Finding::fine) << "the estimate stands";
        for (const double nats : {-judging::kDecisive + 0.1, judging::kDecisive - 0.1}) {
            rival.log_evidence = hearing.claim.log_evidence + nats;
            hearing.ask({rival});
            EXPECT_EQ(hearing.judgement.finding, Finding::ambiguous) << "either may be it";
        }
        rival.log_evidence = hearing.claim.log_evidence + judging::kDecisive + 0.1;
        hearing.ask({rival});
        EXPECT_EQ(hearing.judgement.finding, Finding::elsewhere);
        hearing.judgement = {};
    }
}

/// As that of an operator beside that of a checkpoint, against which some nats speak.
TEST(JudgeTest, AWeakerPriorNeedsLessToBeDoubted) {
    Hearing hearing;
    hearing.claims(false);
    const Hypothesis rival = hearing.idea(kThere, -judging::kDecisive - 1);
    hearing.ask({rival});
    EXPECT_EQ(hearing.judgement.finding, Finding::fine);
    hearing.claim.log_evidence = -3;
    hearing.ask({rival});
    EXPECT_EQ(hearing.judgement.finding, Finding::ambiguous);
}

TEST(JudgeTest, TwoThatAreAlikeAreAmbiguous) {
    for (const int estimate : {0, 1, 2}) {
        Hearing hearing;
        if (estimate > 0) hearing.claims(estimate == 2);
        for (int frame = 0; frame < 10; ++frame) {
            const auto best = hearing.idea(kThere, 30);
            const auto close = hearing.idea(kElsewhere, 30 - judging::kDecisive + 0.1);
            EXPECT_EQ(hearing.ask({best, close}), -1) << "estimate " << estimate;
            EXPECT_EQ(hearing.judgement.finding, Finding::ambiguous);
            EXPECT_EQ(hearing.judgement.held, 0);
            EXPECT_NEAR(hearing.judgement.margin, judging::kDecisive - 0.1, 1e-9);
            hearing.move();
        }
    }
}

TEST(JudgeTest, TheBestWinsByItsLeadBeforeTheSecondWhateverTheirOrder) {
    for (const std::size_t first : {0U, 1U}) {
        Hearing hearing;
        int winner = -1;
        for (int frame = 0; frame < judging::kFrames; ++frame) {
            std::vector<Hypothesis> found(3,
                                          hearing.idea(kElsewhere, 30 - judging::kDecisive - 0.1));
            found[2] = hearing.idea({8, 8, 0}, 10);
            found[first] = hearing.idea(kThere, 30);
            winner = hearing.ask(found);
            hearing.move();
        }
        EXPECT_EQ(winner, static_cast<int>(first));
    }
}

TEST(JudgeTest, ALeaderThatStandsTakesMoreFrames) {
    Hearing hearing;
    int frames = 1;
    for (; hearing.ask({hearing.idea(kThere, 30)}) < 0 && frames < 100; ++frames)
        hearing.move(0.01, 0.008);
    EXPECT_EQ(frames, judging::kMoreFrames)
        << "what misleads a robot that stands does so again and again";
}

/// Or after a turn, whichever comes first.
TEST(JudgeTest, ALeaderHasToHoldOverAWay) {
    struct Steps {
        double distance_m, turn_rad;
        int frames;
    };
    for (const Steps& steps :
         {Steps{judging::kWay_m / 6 + 1e-6, 0, 7}, Steps{0, judging::kWay_rad / 6 + 1e-6, 7},
          Steps{0, -judging::kWay_rad / 6 - 1e-6, 7}, Steps{1, 0, judging::kFrames}}) {
        Hearing hearing;
        int frames = 1;
        while (hearing.ask({hearing.idea(kThere, 30)}) < 0 && frames < 100) {
            hearing.move(steps.distance_m, steps.turn_rad);
            ++frames;
        }
        EXPECT_EQ(frames, steps.frames) << steps.distance_m << " m, " << steps.turn_rad << " rad";
    }
}

/// It is the robot's place of before that speaks from older sightings.
TEST(JudgeTest, ALeaderHasToExplainTheNewestSightings) {
    for (const int clutter : {judging::kClutterOfLatest, judging::kClutterOfLatest + 1}) {
        Hearing hearing;
        int winner = -1;
        for (int frame = 0; frame < judging::kFrames; ++frame) {
            Hypothesis idea = hearing.idea(kThere, 30);
            idea.clutter = clutter;
            winner = hearing.ask({idea});
            hearing.move();
        }
        EXPECT_EQ(winner, clutter == judging::kClutterOfLatest ? 0 : -1);
    }
}

/// Two may be swapped, or one be moved.
TEST(JudgeTest, AConfirmedEstimateFallsToThreeMarkersOnlyIfTheMapHasThem) {
    for (const bool confirmed : {false, true})
        for (const int wanted : {2, judging::kMarkers})
            for (const int markers : {1, 2, 3}) {
                Hearing hearing;
                hearing.claims(confirmed);
                hearing.claim.markers = wanted;
                const bool enough = !confirmed || markers >= wanted;
                for (int frame = 1; frame <= 2 * judging::kMoreFrames; ++frame) {
                    Hypothesis few = hearing.idea(kThere, 30);
                    few.markers = first_markers(markers);
                    EXPECT_EQ(hearing.ask({few}), enough && frame >= judging::kFrames ? 0 : -1)
                        << "frame " << frame;
                    EXPECT_EQ(hearing.judgement.finding, Finding::elsewhere) << "it is not OK";
                    hearing.move();
                }
            }
}

/// A rival that has led leaves doubt, though the estimate explains the sightings as well.
TEST(JudgeTest, AnEstimateThatWasDoubtedHasToStandOutAgain) {
    for (const bool confirmed : {false, true}) {
        Hearing hearing;
        hearing.claims(confirmed);
        const Hypothesis rival = hearing.idea(kThere, 2 * judging::kDecisive);
        const auto finding_with = [&](const std::vector<Hypothesis>& found) {
            hearing.ask(found);
            return hearing.judgement.finding;
        };
        const Hypothesis weaker = hearing.idea(kThere, -judging::kDecisive - 1);
        const Hypothesis alike = hearing.idea(kThere, -judging::kDecisive + 1);
        const Hypothesis itself = hearing.idea({0, 0, 0}, 0);
        EXPECT_EQ(finding_with({}), Finding::fine) << "nothing speaks against it";
        EXPECT_EQ(finding_with({rival}), Finding::elsewhere);
        EXPECT_EQ(finding_with({}), Finding::ambiguous) << "nothing speaks for it";
        EXPECT_EQ(finding_with({itself, alike}), Finding::ambiguous);
        EXPECT_EQ(finding_with({itself, weaker}), Finding::fine);
        EXPECT_EQ(finding_with({alike}), confirmed ? Finding::fine : Finding::ambiguous)
            << "one that is trusted is not doubted for so little";
    }
}

/// There may be a better pose where it has not looked.
TEST(JudgeTest, ASearchThatCouldNotTryAllTakesMoreFrames) {
    Hearing hearing;
    hearing.whole = false;
    int frames = 1;
    for (; hearing.ask({hearing.idea(kThere, 30)}) < 0 && frames < 100; ++frames) hearing.move();
    EXPECT_EQ(frames, judging::kMoreFrames);
}

TEST(JudgeTest, ARowThatIsBrokenStartsAnew) {
    const auto breaks = {
        +[](Hearing&) { return std::vector<Hypothesis>(); },
        +[](Hearing& h) { return std::vector<Hypothesis>{h.idea(kThere, judging::kDecisive - 1)}; },
        +[](Hearing& h) {
            return std::vector<Hypothesis>{h.idea(kThere, 30), h.idea(kElsewhere, 29)};
        }};
    for (const auto& broken : breaks) {
        Hearing hearing;
        for (int frame = 1; frame < judging::kFrames; ++frame) {
            hearing.ask({hearing.idea(kThere, 30)});
            hearing.move();
        }
        EXPECT_EQ(hearing.ask(broken(hearing)), -1);
        EXPECT_EQ(hearing.judgement.held, 0);
        hearing.move();
        (void)hearing.ask_to_the_end(kThere, 30);
    }
}

TEST(JudgeTest, AnotherLeaderStartsAnew) {
    Hearing hearing;
    for (int frame = 0; frame < 20; ++frame) {
        EXPECT_EQ(hearing.ask({hearing.idea(frame % 2 == 0 ? kThere : kElsewhere, 30)}), -1);
        EXPECT_EQ(hearing.judgement.held, 1);
        hearing.move();
    }
}

/// Some pose explains what little was seen, over a wide range.
TEST(JudgeTest, AVaguePoseIsNoneYet) {
    for (const int entry : {kX, kY, kHeading}) {
        Hearing hearing;
        const double most = entry == kHeading ? judging::kVaguest_rad2 : judging::kVaguest_m2;
        for (int frame = 0; frame < 2 * judging::kFrames; ++frame) {
            Hypothesis vague = hearing.idea(kThere, 30);
            vague.covariance(entry, entry) = 1.01 * most;
            EXPECT_EQ(hearing.ask({vague}), -1);
            EXPECT_EQ(hearing.judgement.finding, Finding::elsewhere);
            EXPECT_EQ(hearing.judgement.held, 0);
            hearing.move();
        }
        for (int frame = 1; frame <= judging::kFrames; ++frame) {
            Hypothesis sure = hearing.idea(kThere, 30);
            sure.covariance(entry, entry) = 0.99 * most;
            EXPECT_EQ(hearing.ask({sure}), frame < judging::kFrames ? -1 : 0);
            hearing.move();
        }
    }
}

/// It must go where dead reckoning says that the robot went.
TEST(JudgeTest, ALeaderThatDoesNotMoveWithTheRobotStartsAnew) {
    Hearing hearing;
    const Hypothesis stays = hearing.idea(kThere, 30);
    for (int frame = 0; frame < 9; ++frame) {
        EXPECT_EQ(hearing.ask({stays}), -1);
        EXPECT_EQ(hearing.judgement.held, 1);
        hearing.move(0.3, 0.1);
    }
}

TEST(JudgeTest, WhatIsTheEstimateItselfIsNoRival) {
    const double sigma_m = std::sqrt(0.01 + 4e-4), sigma_rad = std::sqrt(0.001 + 1e-4);
    for (const bool confirmed : {false, true}) {
        for (const Pose<double>& same :
             {Pose<double>(0, 0, 0), Pose<double>(0.2, -0.2, 0.09),
              Pose<double>(3.9 * sigma_m, 0, 0), Pose<double>(0, 0, -3.9 * sigma_rad),
              Pose<double>(0, 0.29, 2 * kPi<double> - 0.09)}) {
            Hearing hearing;
            hearing.claims(confirmed);
            EXPECT_EQ(hearing.ask({hearing.idea(same, 100)}), -1) << same.transpose();
            EXPECT_EQ(hearing.judgement.finding, Finding::fine) << same.transpose();
        }
        for (const Pose<double>& other :
             {Pose<double>(4.1 * sigma_m, 0, 0), Pose<double>(0, 0, 4.1 * sigma_rad)}) {
            Hearing hearing;
            hearing.claims(confirmed);
            hearing.ask({hearing.idea(other, 100)});
            EXPECT_EQ(hearing.judgement.finding, Finding::elsewhere) << other.transpose();
        }
    }
}

/// However sure both are, twenty centimetres are no other pose: the filter goes there by itself.
TEST(JudgeTest, WhatIsNextToASureEstimateIsNoRival) {
    Hearing hearing;
    hearing.claims(true);
    hearing.claim.covariance *= 1e-6;
    Hypothesis next = hearing.idea({0.19, 0, -0.09}, 100);
    next.covariance *= 1e-6;
    hearing.ask({next});
    EXPECT_EQ(hearing.judgement.finding, Finding::fine);
    next.pose[kX] = 0.21;
    hearing.ask({next});
    EXPECT_EQ(hearing.judgement.finding, Finding::elsewhere);
}

/// An unsure estimate foretells little of what it then sees: what is made of that by the pose that
/// it will become speaks for it.
TEST(JudgeTest, WhatIsTheEstimateItselfSpeaksForIt) {
    for (const bool confirmed : {false, true}) {
        Hearing hearing;
        hearing.claims(confirmed);
        for (int frame = 0; frame < 20; ++frame) {
            EXPECT_EQ(hearing.ask({hearing.idea(kThere, 60), hearing.idea(kHere, 59)}), -1);
            EXPECT_EQ(hearing.judgement.finding, confirmed ? Finding::fine : Finding::ambiguous);
            EXPECT_NEAR(hearing.judgement.margin, 1, 1e-9);
            hearing.move();
        }
        int winner = -1;
        for (int frame = 0; frame < judging::kFrames; ++frame) {
            winner = hearing.ask({hearing.idea(kThere, 60), hearing.idea(kHere, 30)});
            hearing.move();
        }
        EXPECT_EQ(winner, 0) << "by 30 nats";
    }
}

TEST(IdeasTest, MoveWithTheRobot) {
    Ideas ideas;
    Pose<double> recalled[Ideas::kMost];
    EXPECT_EQ(ideas.recall(kThere, recalled), 0);
    const Pose<double> then(3, 2, 1), now = after_arc(then, 0.7, 0.4);
    std::vector<Hypothesis> found(2);
    for (std::size_t i = 0; i < 2; ++i) found[i].pose = i == 0 ? kThere : kElsewhere;
    ideas.remember({found.data(), 2}, then);
    const Ideas copy = ideas;
    ASSERT_EQ(copy.recall(now, recalled), 2);
    EXPECT_TRUE(same_pose(recalled[0], after_arc(kThere, 0.7, 0.4), 1e-12));
    EXPECT_TRUE(same_pose(recalled[1], after_arc(kElsewhere, 0.7, 0.4), 1e-12));
    ideas.remember({}, now);
    EXPECT_EQ(ideas.recall(now, recalled), 0);
}

}  // namespace
}  // namespace pilotage::test

// Forward dynamics and derivatives of inverse dynamics by Pinocchio's headers, one line per figure;
// with loops, forward dynamics alone.
#define PINOCCHIO_WITHOUT_TEMPLATE_INSTANTIATION
#define BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS
#define BOOST_MPL_LIMIT_LIST_SIZE 30
#define BOOST_MPL_LIMIT_VECTOR_SIZE 30
#define FUSION_MAX_VECTOR_SIZE 30
#define BOOST_FUSION_INVOKE_MAX_ARITY 10
#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/constrained-dynamics.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace pinocchio;

typedef std::vector<RigidConstraintModel, Eigen::aligned_allocator<RigidConstraintModel>> Loops;
typedef std::vector<RigidConstraintData, Eigen::aligned_allocator<RigidConstraintData>> LoopsData;

static SE3 point(std::istream &cells) {
  double x, y, z;
  cells >> x >> y >> z;
  return SE3(Eigen::Matrix3d::Identity(), Eigen::Vector3d(x, y, z));
}

static Model read(const char *file, std::vector<double> &state, Loops &loops) {
  Model model;
  model.gravity.linear(Eigen::Vector3d(0, 0, -9.81));
  std::ifstream in(file);
  std::vector<JointIndex> joints;
  std::vector<double> q, v;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    std::string name, type;
    int parent;
    double x[18];
    cells >> name >> parent;
    if (name == "close") {
      SE3 first = point(cells);
      int other;
      cells >> other;
      loops.emplace_back(CONTACT_3D, model, joints[parent], first, joints[other], point(cells), LOCAL);
      continue;
    }
    cells >> type;
    for (double &number : x) cells >> number;
    JointIndex above = parent < 0 ? 0 : joints[parent];
    SE3 place(Eigen::Matrix3d::Identity(), Eigen::Vector3d(x[3], x[4], x[5]));
    Eigen::Vector3d axis(x[0], x[1], x[2]);
    JointModel joint;
    bool turns = type == "R";
    if (axis == Eigen::Vector3d::UnitX()) {
      joint = turns ? JointModel(JointModelRX()) : JointModel(JointModelPX());
    } else if (axis == Eigen::Vector3d::UnitY()) {
      joint = turns ? JointModel(JointModelRY()) : JointModel(JointModelPY());
    } else if (axis == Eigen::Vector3d::UnitZ()) {
      joint = turns ? JointModel(JointModelRZ()) : JointModel(JointModelPZ());
    } else {
      joint = turns ? JointModel(JointModelRevoluteUnaligned(axis.normalized()))
                    : JointModel(JointModelPrismaticUnaligned(axis.normalized()));
    }
    JointIndex id = model.addJoint(above, joint, place, name);
    Eigen::Matrix3d inertia;
    inertia << x[10], x[13], x[14], x[13], x[11], x[15], x[14], x[15], x[12];
    model.appendBodyToJoint(id, Inertia(x[6], Eigen::Vector3d(x[7], x[8], x[9]), inertia));
    joints.push_back(id);
    q.push_back(x[16]);
    v.push_back(x[17]);
  }
  state = q;
  state.insert(state.end(), v.begin(), v.end());
  return model;
}

template <class Work> static double best(Work work) {
  double least = 1e300;
  for (int round = 0; round < 401; round++) {
    long count = 0;
    auto begin = std::chrono::steady_clock::now();
    double ns;
    do {
      for (int i = 0; i < 8; i++) work();
      count += 8;
      ns = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
    } while (ns < 1.5e6);
    least = std::min(least, ns / count);
  }
  return least;
}

int main(int argc, char **argv) {
  std::vector<double> state;
  Loops loops;
  Model model = read(argv[1], state, loops);
  Data data(model);
  Eigen::VectorXd q = Eigen::Map<Eigen::VectorXd>(state.data(), model.nq);
  Eigen::VectorXd v = Eigen::Map<Eigen::VectorXd>(state.data() + model.nq, model.nv);
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
  double sign = 1e-9;
  auto move = [&] { q[0] += sign; sign = -sign; };
  if (!loops.empty()) {
    LoopsData loopsData;
    for (const RigidConstraintModel &loop : loops) loopsData.emplace_back(loop);
    initConstraintDynamics(model, data, loops, loopsData);
    // equations that say the same twice: a little compliance, iterated away
    ProximalSettings settings(1e-12, 1e-8, 20);
    auto evaluate = [&] { constraintDynamics(model, data, q, v, tau, loops, loopsData, settings); };
    std::printf("derivative %.1f\n", best([&] { move(); evaluate(); }));
    q[0] = state[0];
    evaluate();
    std::printf("value %.17g\n", data.ddq[model.nv - 1]);
    return 0;
  }
  double world = best([&] { move(); aba(model, data, q, v, tau, Convention::WORLD); });
  double local = best([&] { move(); aba(model, data, q, v, tau, Convention::LOCAL); });
  std::printf("derivative %.1f\n", std::min(world, local));
  Eigen::VectorXd a = aba(model, data, q, v, tau, Convention::LOCAL);
  std::printf("jacobian %.1f\n", best([&] { move(); computeRNEADerivatives(model, data, q, v, a); }));
  std::printf("value %.17g\n", a[model.nv - 1]);
}
